power(10);speed(50)
move(-100,0)
a=0;l=200;d=3
gosub koch
print xpos
end
koch:
if d=0 then line(xpos+l*cos(a),ypos+l*sin(a)); return
local l,d,a
l=l/3;d=d-1
gosub koch
a=a+pi/3; gosub koch
a=a-2*pi/3; gosub koch
a=a+pi/3; gosub koch
return
' (finally counts rapid 1, line 64)
' (finally lines of 474.074074074)
' (finally prints 100)
' (finally machine X100 Y0)
