O1 (G52 shifts the origin of the rotated system: the tool stays, its coordinates change in the turned frame)
G90 G68 X0 Y0 R90.
G00 X10. Y0 (expect moves: rapid X0 Y10)
G52 X5.
#100=#5001 (expect #100=10)
#101=#5002 (expect #101=5)
G91 X1. (expect moves: rapid X0 Y11)
M30
