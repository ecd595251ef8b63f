home
speed(120)
power(80)
home
x=0
y=0
k=6
for i=0 to 360
    inc=i*3.14159/180.0
tmp=k*(1+cos(inc));
    r1=tmp*cos(inc)
r2=tmp*sin(inc);
    if (i == 0)  then move(x+r1, y+r2,0);
    line(r1, r2,0);
next
end
