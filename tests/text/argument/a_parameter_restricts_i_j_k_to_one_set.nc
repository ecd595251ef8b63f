(run with: --param IJK=1)
O1 (ARG-4: always #4 #5 #6, the last one wins)
G65 P2 K1. J2. I3. I4.
M30
O2
#100=#6 (expect #100=1)
#101=#5 (expect #101=2)
#102=#4 (expect #102=4)
#103=#7 (expect #103=null)
M99
