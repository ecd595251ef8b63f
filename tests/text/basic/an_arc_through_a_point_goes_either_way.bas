power(1);speed(1)
move(10,0)
arc(0,10,0,-10,0,0) ' (expect moves: ccw X-10 Y0 @0,0)
arc(0,10,0,10,0,0) ' (expect moves: cw X10 Y0 @0,0)
arc(0,0,10,-10,0,0) ' (expect moves: space-arc X-10 Y0 Z0)
print moved
' (finally prints 31.41592654)
