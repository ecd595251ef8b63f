O1 (section 8.5: until the first absolute move the tool's place is the centre)
G91 G00 X5.
G68 X0 Y0 R90.
X1. (expect moves: rapid X5 Y1)
Y1. (expect moves: rapid X4 Y1)
G90 X3. Y0 (expect moves: rapid X0 Y3)
M30
