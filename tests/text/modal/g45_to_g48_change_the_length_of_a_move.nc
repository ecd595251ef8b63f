(run with: --set #13001=5)
O1 (section 8.1: by one or two radii)
G91 G00 G45 X10. D1 (expect moves: rapid X15)
G46 X10. (expect moves: rapid X20)
G47 X10. (expect moves: rapid X40)
M30
