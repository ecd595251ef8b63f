(run with: --machine lathe2 --max-motions 5)
O1 (Bar jobs)
G00X50.Z5.
G00X60.
M99
(finally status budget)
(finally records: message M99 begins the program again, as a bar job wants: nothing else ends it)
