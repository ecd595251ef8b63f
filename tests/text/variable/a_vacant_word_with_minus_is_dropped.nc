O1 (VAR-7: X-#1 is dropped, not X0)
G90 G00 X5.
X-#1 Y2. (expect moves: rapid X5 Y2)
M30
