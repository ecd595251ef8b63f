O1 (G-7, CYC-5)
M03 S500
G99 G84 X10. Z-5. R2. F500 (expect moves: rapid X10 free; rapid Z2 free; line Z-5 fixed; line Z2 fixed)
X20. (expect moves: rapid X20 free; line Z-5 fixed; line Z2 fixed)
G74 X30. (expect moves: rapid X30 free; line Z-5 fixed; line Z2 fixed)
G81 X40. (expect moves: rapid X40 free; line Z-5 free; rapid Z2 free)
G84 G01 X50. (expect moves: line X50 free)
M30
