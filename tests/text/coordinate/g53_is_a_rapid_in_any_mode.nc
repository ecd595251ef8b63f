O1 (WCS-6: and G01 is on afterwards)
G01 F100
G53 X10. (expect moves: rapid X10)
X20. (expect moves: line X20)
M30
