O1 (LEX-2: no line feed between these blocks)#100=1#101=#100+1M30
(finally #100=1, #101=2)
