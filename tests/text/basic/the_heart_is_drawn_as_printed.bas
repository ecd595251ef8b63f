home
speed(120) ' (expect warning LW0002 at speed)
power(80)
home
x=0
y=0
k=6
n=2; total=0; far=0
for i=0 to 360
    inc=i*3.14159/180.0
tmp=k*(1+cos(inc));
    r1=tmp*cos(inc)
r2=tmp*sin(inc);
    if (i == 0)  then move(x+r1, y+r2,0); n=n+1
    line(r1, r2,0); n=n+1; total=total+moved
if i=1 then if abs(r1-(11.997259))+abs(r2-(0.209413))<1.1e-6 then far=far+1
if i=15 then if abs(r1-(11.393632))+abs(r2-(3.052912))<1.1e-6 then far=far+1
if i=30 then if abs(r1-(9.696156))+abs(r2-(5.598073))<1.1e-6 then far=far+1
if i=45 then if abs(r1-(7.242647))+abs(r2-(7.242638))<1.1e-6 then far=far+1
if i=60 then if abs(r1-(4.500009))+abs(r2-(7.794229))<1.1e-6 then far=far+1
if i=90 then if abs(r1-(0.000008))+abs(r2-(6.000008))<1.1e-6 then far=far+1
if i=120 then if abs(r1-(-1.500000))+abs(r2-(2.598087))<1.1e-6 then far=far+1
if i=135 then if abs(r1-(-1.242644))+abs(r2-(1.242649))<1.1e-6 then far=far+1
if i=150 then if abs(r1-(-0.696157))+abs(r2-(0.401929))<1.1e-6 then far=far+1
if i=179 then if abs(r1-(-0.000914))+abs(r2-(0.000016))<1.1e-6 then far=far+1
if i=180 then if abs(r1-(0))+abs(r2-(0))<1.1e-6 then far=far+1
if i=181 then if abs(r1-(-0.000913))+abs(r2-(-0.000016))<1.1e-6 then far=far+1
if i=210 then if abs(r1-(-0.696146))+abs(r2-(-0.401917))<1.1e-6 then far=far+1
if i=240 then if abs(r1-(-1.500000))+abs(r2-(-2.598055))<1.1e-6 then far=far+1
if i=270 then if abs(r1-(-0.000024))+abs(r2-(-5.999976))<1.1e-6 then far=far+1
if i=300 then if abs(r1-(4.499954))+abs(r2-(-7.794229))<1.1e-6 then far=far+1
if i=315 then if abs(r1-(7.242593))+abs(r2-(-7.242660))<1.1e-6 then far=far+1
if i=330 then if abs(r1-(9.696113))+abs(r2-(-5.598116))<1.1e-6 then far=far+1
if i=359 then if abs(r1-(11.997257))+abs(r2-(-0.209476))<1.1e-6 then far=far+1
if i=360 then if abs(r1-(12))+abs(r2-(-0.000064))<1.1e-6 then far=far+1
next
print total ' (expect n=364, i=361, far=20)
end
' (finally counts rapid 1, line 360)
' (finally lines of 47.998566)
' (finally prints 47.99856561)
