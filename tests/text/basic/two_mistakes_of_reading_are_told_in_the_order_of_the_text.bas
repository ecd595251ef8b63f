print 1
x=1.2.3 ' (expect alarm LB0021 at 1.2.3)
y=$
