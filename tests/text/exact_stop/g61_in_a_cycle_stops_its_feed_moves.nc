O1 (G-6)
G61 G99 G81 X10. Z-5. R2. F500 (expect moves: rapid X10 pass; rapid Z2 pass; line Z-5 stop; rapid Z2 pass)
G83 X20. Q4. (expect moves: rapid X20; line Z-2 stop; rapid Z2 pass; rapid Z-1 pass; line Z-5 stop; rapid Z2 pass)
M30
