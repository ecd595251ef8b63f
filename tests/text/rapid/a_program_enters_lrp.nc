O1 (section 7.4: G10 L50, LRP)
G10 L50
N1401 R00000000
G11
G00 X10. Y1. (expect moves: rapid X10 nonlinear)
G10 L50
N1401 R00000010
G11
X20. (expect moves: rapid X20 linear)
M30
