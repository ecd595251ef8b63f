O1 (REF-5: group 01 is still G00)
G90 G31 X10. F50
X20. (expect moves: rapid X20)
M30
