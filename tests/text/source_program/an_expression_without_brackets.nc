O1 (section 12.1 as printed: Z#26+1000)
G90 G00 Z10000
#26=6.
Z#26+1000 (expect alarm PS0004)
M30
(finally moves: rapid Z10)
