O1 (section 6.2, specification I: A to K)
G65 P2 A1. B2. C3. I4. J5. K6.
M30
O2
#100=#1+#2*10+#3*100 (expect #100=321)
#101=#4+#5*10+#6*100 (expect #101=654)
M99
