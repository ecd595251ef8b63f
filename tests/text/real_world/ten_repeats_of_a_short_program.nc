O1 (M98P100005 is ten times O0005)
G0 X0 G91
M98P100005
M30
O0005
#100=#100+1
Z-0.5
M99
(finally #100=10)
(finally machine Z-5)
