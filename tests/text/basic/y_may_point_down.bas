' (run with: --param invert_y=1)
power(1);speed(1)
move(10,20) ' (expect moves: rapid X10 Y-20)
line(10,30) ' (expect moves: line X10 Y-30)
circle(0,0,5) ' (expect moves: rapid X5 Y0; cw X5 Y0 @0,0)
arc(0,0,5,0,90) ' (expect moves: cw X0 Y-5 @0,0)
print xpos; ypos
' (finally prints 0 5)
' (finally machine X0 Y-5)
