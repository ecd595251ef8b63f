O1 (WCS-4: Y is as before)
G90 G00 X5. Y5.
G92 X0
X0 Y0 (expect moves: rapid X5 Y0)
M30
