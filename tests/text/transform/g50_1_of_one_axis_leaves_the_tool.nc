O1 (the tool stays when the image ends)
G90 G51.1 X0 Y0
G00 X10. Y5. (expect moves: rapid X-10 Y-5)
G50.1 X0
#100=#5001 (expect #100=-10)
#101=#5002 (expect #101=5)
G91 X1. Y1. (expect moves: rapid X-9 Y-6)
M30
