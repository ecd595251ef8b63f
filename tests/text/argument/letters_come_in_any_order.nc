O1 (ARG-3: but not I J K)
G65 P2 Z3. X1. Y2. A4.
M30
O2
#100=#24 (expect #100=1)
#101=#25 (expect #101=2)
#102=#26 (expect #102=3)
#103=#1 (expect #103=4)
M99
