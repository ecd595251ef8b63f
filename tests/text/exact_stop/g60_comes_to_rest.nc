O1 (G-6)
G60 X10. (expect moves: rapid X10 stop)
G00 X20. (expect moves: rapid X20 pass)
M30
