x=1;end 3;print 4 ' (expect alarm LB0001 at 3)
