O1 (NUL-1: only arithmetic makes 0 of it)
#100=#1 (expect #100=null)
#101=#1*5 (expect #101=0)
#102=#1+#1 (expect #102=0)
M30
