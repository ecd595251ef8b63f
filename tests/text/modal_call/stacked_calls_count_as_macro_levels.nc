(run with: --param macro_levels=2)
O1 (CALL-19: the third one fires inside the others)
G90 G00
G66 P2
G66 P3
G66 P4
X1.
M30
O2
#100=1
M99
O3
Y1.
M99
O4
Z1.
M99
(finally alarm PS0122)
(finally #100=null)
