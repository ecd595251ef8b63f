O1 (CYC-13: M29 S before G84)
G90 G00 Z10.
M29 S500
G99 G84 X0 Y0 Z-10. R2. F500 (expect moves: rapid Z2; line Z-10; line Z2)
G80
M30
