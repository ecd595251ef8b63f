power(1);speed(1)
arc(10,0,5,180,90) ' (expect moves: rapid X5 Y0; cw X10 Y5 @10,0)
arc(10,0,5,90,0) ' (expect moves: cw X15 Y0 @10,0)
