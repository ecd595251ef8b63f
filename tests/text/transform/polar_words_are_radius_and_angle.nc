O1 (G16: from the work zero in G90)
G90 G16
G00 X100. Y30. (expect moves: rapid X86.6025 Y50)
G15
X0 Y0 (expect moves: rapid X0 Y0)
M30
