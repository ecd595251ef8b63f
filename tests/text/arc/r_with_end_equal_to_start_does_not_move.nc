O1 (ARC-4: 0 degrees, not 360)
G02 R5. F100 (expect moves: none)
X0 Y0 R5. (expect moves: none)
M30
