(run with: --set #13001=5)
O1 (section 9, G18: the first axis is Z, left of it is plus X)
G90 G00 Z-20. X-10.
G18 G41 D1 G01 Z0 X0 F100
Z50.
X-50.
G40 Z80.
M30
(finally moves: rapid X-10 Z-20; line X5 Z0; line X5 Z55; line X-50 Z55; line X-50 Z80)
