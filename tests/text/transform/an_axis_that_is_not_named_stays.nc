O1 (a transformation moves nothing by itself: the next move moves the axes that it names)
G90 G00 X10. Y5. Z5.
G51 X0 Y0 Z0 P2000
X20. (expect moves: rapid X40 Y5 Z5)
#100=#5002 (expect #100=2.5)
G50
G51.1 X0
Y8. (expect moves: rapid X40 Y8 Z5)
X40. (expect moves: rapid X-40 Y8)
M30
