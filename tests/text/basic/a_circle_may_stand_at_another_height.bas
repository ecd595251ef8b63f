power(1);speed(1)
circle(1,2,-3,4) ' (expect moves: rapid X5 Y2 Z-3; ccw X5 Y2 Z-3 @1,2)
