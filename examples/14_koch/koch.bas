' Koch's snowflake: the middle third of every line becomes a tooth, four times.
' Laser on felt 400 x 450 mm, zero in the centre.

levels=4
side=360

home
speed(60)
power(35)
x=-side/2; y=side/sqr(12)   ' upper left corner of the triangle
move(x, y)
angle=0
for edge=1 to 3
 l=side; n=levels
 gosub koch
 angle=angle-120
next
print "left open:"; dist(-side/2, side/sqr(12)); "mm"
end

koch:             ' l long from x, y towards angle; x, y go along, l and n stay
 if n=0 then x=x+l*cos(rad(angle)); y=y+l*sin(rad(angle)); line(x, y); return
 local l, n       ' what they were comes back at RETURN
 l=l/3; n=n-1
 gosub koch
 angle=angle+60;  gosub koch
 angle=angle-120; gosub koch
 angle=angle+60;  gosub koch
return
