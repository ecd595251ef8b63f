O1 (NUM-14: digits behind the increment do not count as too many)
G90 G00 X1.12345678 (expect moves: rapid X1.123)
M30
