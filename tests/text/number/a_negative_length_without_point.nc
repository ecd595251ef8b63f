O1 (NUM-11: X-25000 is -25 mm)
G90 G00 X-25000 (expect moves: rapid X-25)
M30
