speed(10);power(50)
line(1,0)
x=1/0 ' (expect alarm LB0016 at /)
' (finally records: power 50; line X1 Y0 Z0 F600; power 0)
