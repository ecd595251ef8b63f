O1 (WCS-5: of the named axis)
G90 G00 X5. Y5.
G92 X0 Y0
G92.1 X0
#100=#5001 (expect #100=5)
X1. Y1. (expect moves: rapid X1 Y6)
M30
