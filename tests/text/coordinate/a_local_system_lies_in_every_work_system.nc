O1 (WCS-3: also in G55)
#5241=100.
G52 X10. Y20.
G55 G90 G00 X0 Y0 (expect moves: rapid X110 Y20)
M30
