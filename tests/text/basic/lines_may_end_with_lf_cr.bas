a=1
print a
' (finally prints 1)
