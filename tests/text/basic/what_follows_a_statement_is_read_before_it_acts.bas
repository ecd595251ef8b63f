x=1
power(50)
if x=2 then end 3
if x=2 then return 3
if x=2 then line(9,9) line(8,8)
if x=2 then local x y
if x=2 then input x,y
if x=2 then x=3 4
line(1,0);line(2,0) line(3,0) ' (expect alarm LB0001 at line)
' (finally x=1)
' (finally lines of 1)
