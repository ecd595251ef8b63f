power(1);speed(1)
move(5,0)
arc(0,0,5,0,450) ' (expect moves: ccw X0 Y5 @0,0)
print moved
arc(0,0,5,90,-630) ' (expect moves: cw X0 Y5 @0,0)
print moved
arc(0,0,5,90,450) ' (expect moves: ccw X0 Y5 @0,0)
print moved
' (finally prints 39.26990817)
' (finally prints 62.83185307)
' (finally prints 31.41592654)
