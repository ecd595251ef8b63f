O1 (VAR-7, NUL-6: Y#1 with #1 vacant is not there)
G90 G00 X10. Y10.
X20. Y#1 (expect moves: rapid X20 Y10)
M30
