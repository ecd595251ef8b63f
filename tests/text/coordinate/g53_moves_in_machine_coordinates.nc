O1 (WCS-6: and only in its block)
#5221=3.
G90 G53 G00 X-10. Z0 (expect moves: rapid X-10)
G00 X0 (expect moves: rapid X3)
M30
