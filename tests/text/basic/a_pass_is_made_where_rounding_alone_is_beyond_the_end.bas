n=0
for x=0 to 0.3 step 0.1
n=n+1
next
print n
' (finally prints 4)
