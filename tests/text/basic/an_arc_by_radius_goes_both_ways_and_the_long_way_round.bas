power(1);speed(1)
move(10,0)
arc(0,10,10,1) ' (expect moves: ccw X0 Y10 @0,0)
arc(10,0,10,-1) ' (expect moves: cw X10 Y0 @0,0)
arc(0,10,-10,1) ' (expect moves: ccw X0 Y10 @10,10)
arc(10,0,-10,-1) ' (expect moves: cw X10 Y0 @10,10)
print moved
' (finally prints 47.1238898)
