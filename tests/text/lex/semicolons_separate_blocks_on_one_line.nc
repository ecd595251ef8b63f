O1 (LEX-2: one line may hold several blocks, also empty ones)
#100=1;#101=#100+1;;#102=#101+1
M30
(finally #100=1, #101=2, #102=3)
