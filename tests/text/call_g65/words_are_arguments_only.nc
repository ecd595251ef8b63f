O1 (CALL-4: no motion, no tool, no spindle)
#100=#4120
#101=#4119
G65 P2 X10. T5 S800
M30
O2
#102=#20 (expect #102=5)
#103=#19 (expect #103=800)
#104=#4120-#100 (expect #104=0)
#105=#4119-#101 (expect #105=0)
M99
(finally moves: none)
