O1 (section 7.2: X[#ABC])
SETVN500[ABC]
[#ABC]=4.
G90 G00 X[#ABC] (expect moves: rapid X4)
M30
