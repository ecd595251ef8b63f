(run with: --machine arm4)
O0001 (the move of line 8 is held until that of line 9 is known)
G10 L12 P1 R10.
G01 X200. Y50. F600.
G41 D1 X200. Y100.
X150. Y150.
#100=1
X250. (expect alarm OUT_OF_REACH says the tip X260 Y160) (expect moves: none)
X100. Y20.
G40 X100. Y50.
M30
(finally #100=1)
