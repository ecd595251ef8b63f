' A spectacle lens out of a round blank: the rim is scribed, then cut.
' X0 Y0 = axis of the work, Z0 = top of the lens, a sphere.

front=130         ' radius of the sphere
temple=28         ' half widths and half heights of the rim
nose=25
brow=21.5
cheek=20.5
n=2.6             ' 2 would be an ellipse, more is squarer

speed(30)         ' no HOME: on the axis no angle of the work is determined
power(15)
gap=0
gosub rim         ' scribe it as it will be
print "the rim is"; length; "mm long"
power(20)
for b=0 to 315 step 45
 gosub tick       ' and how it will sit in the frame
next
speed(8)
power(90)
gap=0.4           ' cut beside it: this much is ground off
gosub rim
gosub rim         ' once more, further round the same way
end

rim:              ' once round, by arcs of 6 degrees through the rim's points
 a=0
 gosub point
 if dist(x, y, z)>0.000001 then move(x, y, z)
 length=0
 for turn=1 to 60
  a=6*turn-3
  gosub point
  x1=x; y1=y; z1=z
  a=6*turn
  gosub point
  arc(x1, y1, z1, x, y, z)
  length=length+moved
 next
return

tick:             ' outwards from the rim at angle b
 a=b; gap=1; gosub point
 move(x, y, z)
 gap=4; gosub point
 line(x, y, z)
return

point:            ' of the rim at angle a, gap further out: x, y, z
 c=cos(rad(a)); s=sin(rad(a))
 w=temple; if c<0 then w=nose
 h=brow; if s<0 then h=cheek
 r=gap+(abs(c/w)^n+abs(s/h)^n)^(-1/n)
 x=r*c; y=r*s
 z=sqr(front*front-r*r)-front
return
