' A square with a square half its size on each corner, and so on.
' Laser on plywood 500 x 500 mm, zero in the centre.

home
speed(80)
power(40)
count=0
x=0; y=0          ' centre of the square
s=120             ' half its side
gosub square
move(0, 0)
print count; "squares"
end

square:           ' centre x, y, half side s: it leaves them as they were
 if s<7 then return
 count=count+1
 move(x-s, y-s)
 line(x+s, y-s); line(x+s, y+s); line(x-s, y+s); line(x-s, y-s)
 s=s/2
 x=x-2*s; y=y-2*s; gosub square
 x=x+4*s;          gosub square
          y=y+4*s; gosub square
 x=x-4*s;          gosub square
 x=x+2*s; y=y-2*s
 s=2*s
return
