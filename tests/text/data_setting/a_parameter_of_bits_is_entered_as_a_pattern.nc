O1 (section 7.4: 3401#0 is DPI, the other bits are not Kerf's)
G10 L50
N3401 R00000001
G11
G90 G00 X20 (expect moves: rapid X20)
G10 L50
N3401 R00000000
G11
X20 (expect moves: rapid X0.020)
M30
