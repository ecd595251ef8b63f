O1 (G-6)
G09 G99 G85 X10. Z-5. R2. F500 (expect moves: rapid X10 stop; rapid Z2 stop; line Z-5 stop; line Z2 stop)
X20. (expect moves: rapid X20 pass; line Z-5 pass; line Z2 pass)
M30
