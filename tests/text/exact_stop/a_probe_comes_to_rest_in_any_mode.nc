O1 (G-6)
G31 X10. F100 (expect moves: probe X10 stop fixed)
#3004=4
G31 X20. (expect moves: probe X20 stop fixed)
M30
