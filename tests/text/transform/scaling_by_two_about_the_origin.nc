O1 (G51: P2000 is 2)
G51 X0 Y0 P2000
G90 G00 X3. Y4. (expect moves: rapid X6 Y8)
#100=#5041 (expect #100=6)
#101=#5042 (expect #101=8)
M30
