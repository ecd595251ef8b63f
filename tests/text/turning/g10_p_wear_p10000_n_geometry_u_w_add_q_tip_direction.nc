(run with: --machine lathe2)
O1 (G10 P: wear, P10000+n: geometry, U W add, Q tip direction)
G97S500M03
G10P3X-.1Z.05R.4Q3
G10P10003X12.Z-5.
G10P3U.03
#100=#2003
#101=#2103
#102=#2203
#103=#2303
#104=#2703
#105=#2803
M30
(finally #100=-0.07, #101=0.05, #102=0.4, #103=3, #104=12, #105=-5)
