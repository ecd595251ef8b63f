O1 (G92 in a rotated frame: the point reads as given, and the next increment starts there)
G90 G68 X0 Y0 R90.
G00 X10. Y4. (expect moves: rapid X-4 Y10)
G92 X1. Y2.
#100=#5001 (expect #100=1)
#101=#5002 (expect #101=2)
G91 X1. (expect moves: rapid X-4 Y11)
G90 X1. Y2. (expect moves: rapid X-4 Y10)
M30
