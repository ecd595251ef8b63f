HOME ' (expect moves: none)
SPEED(50)
POWER(60)
MOVE(10,20,0) ' (expect moves: rapid X10 Y20 Z0 linear)
Line(40, 60 ,0) ' (expect moves: line X40 Y60 F3000)
print xpos; ypos; zpos; moved; dist(0,0)
CIRCLE(0,0,5) ' (expect moves: rapid X5 Y0; ccw X5 Y0 @0,0 XY F3000)
ARC(5,0,5,0,90) ' (expect moves: rapid X10 Y0; ccw X5 Y5 @5,0)
ARC(0,0,5,1) ' (expect moves: ccw X0 Y0 @5,0)
ARC(10,0,0,10,10,0) ' (expect moves: ccw X10 Y10 @5,5)
print moved
end
print "unreached"
' (finally prints 40 60 0 50 72.11102551)
' (finally prints 22.21441469)
' (finally records: power 60; line X40 Y60 Z0 F3000; power 0; power 60; power 0; end)
